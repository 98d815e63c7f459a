namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Positions of both codes in a picture, px; y points down.</summary>
/// <param name="Control">Centre of the control code.</param>
/// <param name="Headset">Centre of the headset's code.</param>
/// <param name="LaterMs">Time from the exposure of the control code to that of the headset's code, caused by a rolling shutter, ms.</param>
sealed record CodePlaces((double X, double Y) Control, (double X, double Y) Headset, double LaterMs);
