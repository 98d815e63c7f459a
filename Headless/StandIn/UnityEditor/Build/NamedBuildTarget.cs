namespace UnityEditor.Build;

public readonly struct NamedBuildTarget : IEquatable<NamedBuildTarget>, IComparable<NamedBuildTarget>
{
    public static readonly NamedBuildTarget Android = new NamedBuildTarget("Android");
    public static readonly NamedBuildTarget Standalone = new NamedBuildTarget("Standalone");
    public static readonly NamedBuildTarget WindowsStoreApps = new NamedBuildTarget("Windows Store Apps");

    NamedBuildTarget(string targetName) => TargetName = targetName;

    public string TargetName { get; }

    public bool Equals(NamedBuildTarget other) => TargetName == other.TargetName;
    public override bool Equals(object obj) => obj is NamedBuildTarget other && Equals(other);
    public override int GetHashCode() => TargetName == null ? 0 : TargetName.GetHashCode(StringComparison.Ordinal);
    public int CompareTo(NamedBuildTarget other) => string.CompareOrdinal(TargetName, other.TargetName);
}
