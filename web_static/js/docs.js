/** A page of the folder docs: it has the colours that were chosen on this screen. */
import { followSystem } from "./shell/theme.js";

followSystem();
