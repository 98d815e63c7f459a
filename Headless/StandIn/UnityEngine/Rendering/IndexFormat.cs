namespace UnityEngine.Rendering;

public enum IndexFormat
{
    UInt16 = 0,
    UInt32 = 1,
}
