namespace Nowpose.Studies;

/// <summary>One frame of a study; positions in the motion's unit.</summary>
/// <param name="Time">Moment of light, s of control time since the motion's start.</param>
/// <param name="Truth">Where the axis is then.</param>
/// <param name="Held">What a display without compensation shows.</param>
/// <param name="Predicted">What the predictor says.</param>
/// <param name="NewestSample">Index of the newest sample that has arrived.</param>
public readonly record struct StudyFrame(double Time, double Truth, double Held, double Predicted, int NewestSample);
