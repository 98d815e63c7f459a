using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

static class RobotAssets
{
    /// <summary>
    /// The URDF's text in an asset that prefabs may refer to: the assets that an importer creates from a .urdf have fileIDs that only Unity
    /// determines.
    /// </summary>
    public static string Description(Workshop workshop, string path, string urdfPath)
    {
        var asset = ScriptableObject.CreateInstance<RobotDescriptionAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        Fields.Set(asset, "_urdf", workshop.ReadText(urdfPath));
        return workshop.Asset(asset);
    }

    /// <summary>Creates settings for a gateway on this machine without calibration: the class's defaults.</summary>
    public static string Settings(Workshop workshop, string path)
    {
        var asset = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        asset.name = Path.GetFileNameWithoutExtension(path);
        return workshop.Asset(asset);
    }
}
