import './pairing.css';
import { byId } from '../dom';
import { startMarker } from './marker';
import { startToken } from './token';

startToken();
void startMarker();
byId('starting').remove();
