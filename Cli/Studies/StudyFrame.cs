namespace Nowpose.Cli.Studies;

/// <summary>One frame of a study. Positions are in the unit of the motion.</summary>
/// <param name="Time">Display time as control time since the start of the motion, s.</param>
/// <param name="Truth">True position at the display time.</param>
/// <param name="Held">Position displayed without compensation.</param>
/// <param name="Predicted">Predicted position.</param>
public readonly record struct StudyFrame(double Time, double Truth, double Held, double Predicted);
