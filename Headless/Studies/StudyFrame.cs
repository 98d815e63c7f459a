namespace Nowpose.Studies;

/// <summary>One frame of a study; positions in the motion's unit.</summary>
/// <param name="Time">Display time, s of control time since the motion's start.</param>
/// <param name="Truth">True position at that time.</param>
/// <param name="Held">Position shown without compensation.</param>
/// <param name="Predicted">Predicted position.</param>
/// <param name="NewestSample">Index of the newest sample that has arrived.</param>
public readonly record struct StudyFrame(double Time, double Truth, double Held, double Predicted, int NewestSample);
