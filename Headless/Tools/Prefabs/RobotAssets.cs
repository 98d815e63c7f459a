using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

static class RobotAssets
{
    /// <summary>
    /// Creates an asset with the URDF's text that prefabs can reference. The assets that an importer creates from a .urdf file have fileIDs that
    /// only Unity can determine.
    /// </summary>
    public static string Description(PackageAssets assets, string path, string urdfPath)
    {
        var asset = ScriptableObject.CreateInstance<RobotDescriptionAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        Fields.Set(asset, "_urdf", assets.ReadText(urdfPath));
        return assets.Asset(asset);
    }

    /// <summary>Creates settings with the default values of the class: a gateway on this machine, without calibration.</summary>
    public static string Settings(PackageAssets assets, string path)
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        return assets.Asset(asset);
    }
}
