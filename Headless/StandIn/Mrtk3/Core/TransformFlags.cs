namespace MixedReality.Toolkit;

[Flags]
public enum TransformFlags
{
    None = 0,
    Move = 1 << 0,
    Rotate = 1 << 1,
    Scale = 1 << 2,
}
