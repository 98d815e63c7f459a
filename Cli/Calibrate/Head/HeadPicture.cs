namespace Nowpose.Cli.Calibrate.Head;

/// <summary>One picture of a moving headset, along the direction of the motion.</summary>
/// <param name="Seconds">Time since the first picture.</param>
/// <param name="Place">Place of the control's code, px from the mean.</param>
/// <param name="Speed">Speed of the control's code in the picture, px/s.</param>
/// <param name="Offset">
/// Place of the headset's code minus that of the control's, px, at the middle of the time in which the frame was lit.
/// </param>
readonly record struct HeadPicture(double Seconds, double Place, double Speed, double Offset);
