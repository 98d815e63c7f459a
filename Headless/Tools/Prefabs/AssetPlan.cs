using Nowpose.Metas;
using Nowpose.Prefabs.Mrtk3;

namespace Nowpose.Prefabs;

/// <summary>Lists all assets that this tool writes. Each asset comes after the assets that it references.</summary>
public static class AssetPlan
{
    static readonly (string Path, Func<PackageAssets, string> Make)[] Assets =
    [
        .. PackagePaths.Robots.Select(path => (path, (Func<PackageAssets, string>)(w => RobotAssets.Description(w, path)))),
        (PackagePaths.Settings, w => RobotAssets.Settings(w, PackagePaths.Settings)),
        (PackagePaths.Gripper, GripperPrefab.Make),
        (PackagePaths.PoseLabel, Texts.PoseLabel),
        (PackagePaths.Cell, w => CellPrefab.Make(w, PackagePaths.Cell, PackagePaths.Youbot)),
        (PackagePaths.CellUr5, w => CellPrefab.Make(w, PackagePaths.CellUr5, PackagePaths.Ur5)),
        (PackagePaths.CellAnyRobot, w => CellPrefab.Make(w, PackagePaths.CellAnyRobot, null)),
        (PackagePaths.Robot, w => RobotObjects.MakePrefab(w, PackagePaths.Robot, PackagePaths.Youbot)),
        (PackagePaths.DemoScene, Scenes.Demo),
        (PackagePaths.VirtualSettings, w => RobotAssets.Settings(w, PackagePaths.VirtualSettings)),
        (PackagePaths.VirtualScene, VirtualScenes.OneArm),
        (PackagePaths.TwoArmsSettings, w => RobotAssets.Settings(w, PackagePaths.TwoArmsSettings, robotNamespace: VirtualScenes.FirstArm)),
        (PackagePaths.TwoArmsScene, VirtualScenes.TwoArms),
        (PackagePaths.ConnectSettings, w => RobotAssets.Settings(w, PackagePaths.ConnectSettings)),
        (PackagePaths.ConnectScene, w => Scenes.Connect(w, PackagePaths.Cell)),
        (PackagePaths.ConnectSceneAnyRobot, w => Scenes.Connect(w, PackagePaths.CellAnyRobot)),
        (PackagePaths.CalibrationSettings, w => RobotAssets.Settings(w, PackagePaths.CalibrationSettings)),
        (PackagePaths.CalibrationScene, Scenes.DisplayCalibration),
        (PackagePaths.AnyHeadsetSettings, w => RobotAssets.Settings(w, PackagePaths.AnyHeadsetSettings)),
        (PackagePaths.AnyHeadsetScene, AnyHeadsetScene.Make),
        (PackagePaths.HoloLensSettings, w => RobotAssets.Settings(w, PackagePaths.HoloLensSettings)),
        (PackagePaths.HoloLensMenu, HeadsetMenuPrefab.Make),
        (PackagePaths.HoloLensPanel, HoloLensPrefabs.Panel),
        (PackagePaths.HoloLensMarker, HoloLensPrefabs.Marker),
        (PackagePaths.HoloLensConsent, HoloLensPrefabs.Consent),
        (PackagePaths.HoloLensScene, HoloLensScene.Make),
    ];

    public static IEnumerable<string> Paths => Assets.Select(a => a.Path);

    /// <summary>Compares the assets with the files without writing.</summary>
    /// <returns>Paths of the assets that are missing or outdated.</returns>
    public static IReadOnlyList<string> Differing(string root)
    {
        var assets = new PackageAssets(root);
        return Assets.Where(a => Differs(root, a.Path, a.Make(assets))).Select(a => a.Path).ToList();
    }

    /// <returns>Paths of the written assets.</returns>
    public static IReadOnlyList<string> Write(string root)
    {
        var written = new List<string>();
        var assets = new PackageAssets(root);
        foreach (var (path, make) in Assets)
        {
            var text = make(assets);
            if (!Differs(root, path, text)) continue;
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(root, path)));
            File.WriteAllText(Path.Combine(root, path), text);
            MetaWriter.WriteMissing(root);
            written.Add(path);
            // Reloads the assets, so that later ones reference the new version.
            assets = new PackageAssets(root);
        }
        return written;
    }

    static bool Differs(string root, string path, string text)
    {
        var full = Path.Combine(root, path);
        return !File.Exists(full) || File.ReadAllText(full) != text;
    }
}
