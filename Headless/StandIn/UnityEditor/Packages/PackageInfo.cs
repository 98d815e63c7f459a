namespace UnityEditor.PackageManager;

public sealed class PackageInfo
{
    internal PackageInfo(string name, string version)
    {
        this.name = name;
        this.version = version;
    }

    public string name { get; }
    public string version { get; }

    internal static List<PackageInfo> Registered { get; } = new List<PackageInfo>();

    public static PackageInfo[] GetAllRegisteredPackages() => Registered.ToArray();
}
