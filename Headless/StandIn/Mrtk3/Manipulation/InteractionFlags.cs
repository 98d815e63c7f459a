namespace MixedReality.Toolkit.SpatialManipulation;

[Flags]
public enum InteractionFlags
{
    None = 0,
    Near = 1 << 0,
    Ray = 1 << 1,
    Gaze = 1 << 2,
    Generic = 1 << 31,
}
