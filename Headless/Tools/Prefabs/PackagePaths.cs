using Nowpose.Prefabs.Mrtk3;

namespace Nowpose.Prefabs;

/// <summary>Paths of the assets as Unity writes them.</summary>
static class PackagePaths
{
    const string Runtime = "Packages/com.nowpose.mril/Runtime/";
    const string Virtual = "Packages/com.nowpose.mril/Samples~/Virtual Robot Cell/";
    const string Connect = "Packages/com.nowpose.mril/Samples~/Connect to a Gateway/";
    const string Calibration = "Packages/com.nowpose.mril/Samples~/Display Calibration/";

    const string AnyHeadset = "Packages/com.nowpose.mril/Samples~/Any OpenXR headset/";

    const string HoloLens = "Packages/com.nowpose.mril/Samples~/HoloLens 2 (MRTK3)/";

    public const string Hologram = Runtime + "Materials/Hologram.mat";
    public const string Arm = Runtime + "Materials/Arm.mat";
    public const string Ghost = Runtime + "Materials/Ghost.mat";
    public const string Occluder = Runtime + "Materials/Occluder.mat";
    public const string Backdrop = Runtime + "Materials/Backdrop.mat";
    public const string Panel = Runtime + "Materials/Panel.mat";
    public const string Solid = Runtime + "Materials/Solid.mat";
    public const string Workpiece = Runtime + "Materials/Workpiece.mat";
    public const string Text = Runtime + "Materials/Text.mat";
    public const string Timestamp = Runtime + "Materials/Timestamp.mat";
    public const string Youbot = Runtime + "Robots/youBot.asset";
    public const string Ur5 = Runtime + "Robots/UR5.asset";
    public const string Settings = Runtime + "Settings/Default Session Settings.asset";
    public const string Gripper = Runtime + "Prefabs/Virtual Gripper.prefab";
    public const string PoseLabel = Runtime + "Prefabs/Pose Label.prefab";
    public const string Cell = Runtime + "Prefabs/Nowpose Robot Cell.prefab";
    public const string CellUr5 = Runtime + "Prefabs/Nowpose Robot Cell UR5.prefab";
    public const string Robot = Runtime + "Prefabs/Nowpose Robot.prefab";
    public const string VirtualSettings = Virtual + "Virtual Cell Settings.asset";
    public const string VirtualScene = Virtual + "Virtual Robot Cell.unity";
    public const string TwoArmsSettings = Virtual + "Two Arms Settings.asset";
    public const string TwoArmsScene = Virtual + "Virtual Robot Cell (Two Arms).unity";
    public const string CellAnyRobot = Runtime + "Prefabs/Nowpose Robot Cell (Any Robot).prefab";
    public const string ConnectSettings = Connect + "Gateway Settings.asset";
    public const string ConnectScene = Connect + "Connect to a Gateway.unity";
    public const string ConnectSceneAnyRobot = Connect + "Connect to a Gateway (Any Robot).unity";
    public const string CalibrationSettings = Calibration + "Calibration Settings.asset";
    public const string CalibrationScene = Calibration + "Display Calibration.unity";
    public const string AnyHeadsetSettings = AnyHeadset + "Headset Settings.asset";
    public const string AnyHeadsetScene = AnyHeadset + "Any OpenXR headset.unity";
    public const string HoloLensSettings = HoloLens + "HoloLens Settings.asset";
    public const string HoloLensMenu = HoloLens + "Prefabs/Headset Menu.prefab";
    public const string HoloLensPanel = HoloLens + "Prefabs/Status Panel (MRTK3).prefab";
    public const string HoloLensMarker = HoloLens + "Prefabs/Hand-Placed Marker.prefab";
    public const string HoloLensConsent = HoloLens + "Prefabs/Consent Prompt.prefab";
    public const string HoloLensScene = HoloLens + "HoloLens 2 (MRTK3).unity";
    public const string DemoScene = "Assets/Scenes/Demo.unity";

    /// <summary>The descriptions of all robots.</summary>
    public static readonly string[] Robots =
    [
        Youbot, Ur5, Runtime + "Robots/UR3e.asset", Runtime + "Robots/UR5e.asset", Runtime + "Robots/UR10e.asset", Runtime + "Robots/UR16e.asset",
    ];
}
