namespace Nowpose.Cli.Calibrate.Head;

/// <summary>One picture of a moving headset. Positions are measured along the direction of the motion.</summary>
/// <param name="Seconds">Time since the first picture.</param>
/// <param name="Place">Position of the control code relative to its mean, px.</param>
/// <param name="Speed">Speed of the control code in the picture, px/s.</param>
/// <param name="Offset">
/// Position of the headset's code minus position of the control code, px, at the middle of the time in which the frame was lit.
/// </param>
readonly record struct HeadPicture(double Seconds, double Place, double Speed, double Offset);
