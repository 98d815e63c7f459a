namespace UnityEditor;

[Flags]
public enum AndroidArchitecture : uint
{
    ARM64 = 2,
    X86_64 = 8,
}
