import './pairing.css';
import { startMarker } from './marker';
import { startToken } from './token';

startToken();
void startMarker();
