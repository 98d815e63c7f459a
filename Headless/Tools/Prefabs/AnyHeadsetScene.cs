using Nowpose.Prefabs.Mrtk3;
using Nowpose.Samples;

namespace Nowpose.Prefabs;

/// <summary>Creates the scene of a robot cell for a headset with controllers. The user places the base by hand; buttons replace a menu.</summary>
static class AnyHeadsetScene
{
    const string Right = "<XRController>{RightHand}/", Left = "<XRController>{LeftHand}/";

    const float NudgeMs = 1, OpacityStep = 0.1f, ShiftStepMm = 1;

    /// <summary>Initial position of the base: in front of the user, at table height if the user stands.</summary>
    internal static readonly Vector3 BasePlace = new(0, -0.6f, 1.2f);

    public static string Make(PackageAssets assets)
    {
        var cell = Scenes.Cell(assets, PackagePaths.Cell, PackagePaths.AnyHeadsetSettings);
        var session = cell.GetComponent<MrilSession>();
        // Does not connect at startup. A button connects when the user has placed the base.
        Fields.Set(session, "_connectOnEnable", false);
        cell.transform.Find("Base Anchor").localPosition = BasePlace;
        var rig = new GameObject("Tracking Origin");
        var camera = Props.HeadsetCamera();
        camera.transform.SetParent(rig.transform, worldPositionStays: false);
        camera.AddComponent<HeadTracking>();
        AddHandle(assets, cell.transform, rig.transform);
        AddButtons(assets, session);
        return assets.Scene(rig, Props.Light(hasShadows: false), cell);
    }

    /// <summary>Adds the handle whose pose is the robot's base frame. It is a cube of 6 cm, with a nose along the robot's x axis.</summary>
    static void AddHandle(PackageAssets assets, Transform cell, Transform rig)
    {
        var handle = Children.Add("Base Handle", cell, BasePlace);
        AddShape(assets, handle.transform);
        handle.AddComponent<HandPlacedMarker>();
        var carried = handle.AddComponent<CarriedMarker>();
        Fields.Set(carried, "_trackingOrigin", rig);
        Fields.Set(carried, "_anchor", cell.GetComponentInChildren<BaseAnchor>(includeInactive: true));
    }

    internal static void AddShape(PackageAssets assets, Transform handle)
    {
        var look = assets.Load<Material>(PackagePaths.Ghost);
        Children.AddPrimitive(PrimitiveType.Cube, "Block", handle, Vector3.zero, new Vector3(0.06f, 0.06f, 0.06f), look);
        Children.AddPrimitive(PrimitiveType.Cube, "Nose", handle, new Vector3(0, 0, 0.09f), new Vector3(0.015f, 0.015f, 0.12f), look);
    }

    static void AddButtons(PackageAssets assets, MrilSession session)
    {
        var actions = CellObjects.AddActions(assets, session);
        var buttons = Children.Add("Buttons", session.transform);
        // The controller of Magic Leap 2 has a menu button and a trigger, and no primary and secondary button.
        Button(actions, buttons, nameof(CellActions.ToggleConnected), Right + "{PrimaryButton}", Right + "{MenuButton}", "<Keyboard>/c");
        Button(actions, buttons, nameof(CellActions.TogglePanel), Right + "{SecondaryButton}", Right + "{TriggerButton}", "<Keyboard>/p");
        Button(actions, buttons, nameof(CellActions.LockBase), Right + "{Primary2DAxisClick}", "<Keyboard>/l");
        Button(actions, buttons, nameof(CellActions.ToggleGhost), Left + "{PrimaryButton}", "<Keyboard>/g");
        Button(actions, buttons, nameof(CellActions.ToggleOcclusion), Left + "{SecondaryButton}", "<Keyboard>/o");
        Step(actions, buttons, nameof(CellActions.ChangeNudgeMs), NudgeMs, Right + "{Primary2DAxis}/right", "<Keyboard>/rightArrow");
        Step(actions, buttons, nameof(CellActions.ChangeNudgeMs), -NudgeMs, Right + "{Primary2DAxis}/left", "<Keyboard>/leftArrow");
        Step(actions, buttons, nameof(CellActions.ChangeOpacity), OpacityStep, Right + "{Primary2DAxis}/up", "<Keyboard>/upArrow");
        Step(actions, buttons, nameof(CellActions.ChangeOpacity), -OpacityStep, Right + "{Primary2DAxis}/down", "<Keyboard>/downArrow");
        AddCalibration(actions, buttons);
    }

    // Calls for the calibration by eye.
    static void AddCalibration(CellActions actions, GameObject buttons)
    {
        Step(actions, buttons, nameof(CellActions.ChangeShiftMm), ShiftStepMm, Left + "{Primary2DAxis}/right", "<Keyboard>/k");
        Step(actions, buttons, nameof(CellActions.ChangeShiftMm), -ShiftStepMm, Left + "{Primary2DAxis}/left", "<Keyboard>/j");
        Button(actions, buttons, nameof(CellActions.AddMark), Left + "{Primary2DAxisClick}", "<Keyboard>/m");
        Button(actions, buttons, nameof(CellActions.ApplyMarks), Left + "{GripButton}", "<Keyboard>/enter");
        Button(actions, buttons, nameof(CellActions.ClearMarks), Left + "{TriggerButton}", "<Keyboard>/backspace");
    }

    static void Button(CellActions actions, GameObject buttons, string method, params string[] paths) =>
        Calls.Add(Pressed(buttons, paths), "_onPressed", actions, method);

    static void Step(CellActions actions, GameObject buttons, string method, float by, params string[] paths) =>
        Calls.Add(Pressed(buttons, paths), "_onPressed", actions, method, by);

    static PressedAction Pressed(GameObject buttons, string[] paths)
    {
        var pressed = buttons.AddComponent<PressedAction>();
        Fields.Set(pressed, "_bindings", paths);
        return pressed;
    }
}
