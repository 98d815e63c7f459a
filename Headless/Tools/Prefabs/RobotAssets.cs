namespace Nowpose.Prefabs;

static class RobotAssets
{
    /// <summary>
    /// Creates an asset that prefabs can reference. It contains the text of the .urdf file beside it, whose name is in lower case. An importer could
    /// also create it from a .urdf file, but only Unity can determine the fileIDs of imported objects.
    /// </summary>
    public static string Description(PackageAssets assets, string path)
    {
        var asset = ScriptableObject.CreateInstance<RobotDescriptionAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        Fields.Set(asset, "_urdf", assets.ReadText($"{Path.GetDirectoryName(path)}/{asset.name.ToLowerInvariant()}.urdf"));
        return assets.Asset(asset);
    }

    /// <summary>Creates settings with the default values of the class: a gateway on this machine, without calibration.</summary>
    /// <param name="robotNamespace">Namespace of the session's own robot.</param>
    public static string Settings(PackageAssets assets, string path, string robotNamespace = "")
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        Fields.Set(asset, "_robotNamespace", robotNamespace);
        return assets.Asset(asset);
    }
}
