using MixedReality.Toolkit;
using MixedReality.Toolkit.UX;
using Nowpose.Mrtk3;
using Nowpose.Unity.Rendering;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Creates MRTK3's hand menu with the actions of a cell. The actions are also available by voice.</summary>
sealed class HeadsetMenuPrefab
{
    const float NudgeMs = 20, NudgeStepMs = 1, OpacityStep = 0.2f, ShiftStepMm = 1;

    readonly PackageAssets _assets;
    readonly GameObject _root;
    readonly CellActions _actions;
    readonly HeadsetMenu _menu;
    readonly Transform _canvas;
    readonly Buttons _buttons;

    HeadsetMenuPrefab(PackageAssets assets)
    {
        _assets = assets;
        _root = new GameObject("Headset Menu");
        _actions = _root.AddComponent<CellActions>();
        _menu = _root.AddComponent<HeadsetMenu>();
        Fields.Set(_menu, "_actions", _actions);
        var hand = assets.Instantiate(ForeignPaths.HandMenu, _root.transform);
        _canvas = hand.transform.Find("MenuContent-Canvas");
        // The menu is shown only while a hand is held with the palm up.
        _canvas.gameObject.SetActive(false);
        _canvas.Find("Buttons-GridLayout").gameObject.SetActive(false);
        Canvases.AddGround(assets, _canvas, new Vector3(0, -17, 4), new Vector2(112, 174));
        _buttons = new Buttons(assets, _canvas);
    }

    public static string Make(PackageAssets assets)
    {
        var prefab = new HeadsetMenuPrefab(assets);
        prefab.AddButtons();
        prefab.AddSliders();
        prefab.AddVoice();
        return assets.Prefab(prefab._root);
    }

    void AddButtons()
    {
        Toggle("_connect", "Connect", nameof(CellActions.ToggleConnected), new Vector2(-34, 50));
        Click(_buttons.Button("Lock Base", "Lock base", new Vector2(0, 50)), nameof(CellActions.LockBase));
        Toggle("_panel", "Panel", nameof(CellActions.TogglePanel), new Vector2(34, 50));
        Toggle("_ghost", "Ghost", nameof(CellActions.ToggleGhost), new Vector2(-34, 16));
        Toggle("_occlusion", "Occlusion", nameof(CellActions.ToggleOcclusion), new Vector2(0, 16));
        // This button is apart from the other buttons and asks for confirmation, because it must not be pressed by mistake.
        Click(_buttons.Button("Forget Cell", "Forget cell", new Vector2(34, -86)), nameof(CellActions.ForgetCell));
        Calls.Add(_buttons.Button("No Nudge", "No nudge", new Vector2(34, 16)), Clicked, _actions, nameof(CellActions.SetNudgeMs), 0f);
    }

    void AddSliders()
    {
        const int steps = (int)(2 * NudgeMs / NudgeStepMs);
        Slide("_nudge", _buttons.Slider("L_visu Nudge", -NudgeMs, NudgeMs, 0, new Vector2(0, -22), steps), nameof(HeadsetMenu.SlideNudge));
        Fields.Set(_menu, "_nudgeWords", Canvases.AddText(_assets, "L_visu Nudge Words", _canvas, new Vector3(0, -10, 0)));
        Slide("_opacity", _buttons.Slider("Opacity", 0, 1, 1, new Vector2(0, -54)), nameof(HeadsetMenu.SlideOpacity));
        Fields.Set(_menu, "_opacityWords", Canvases.AddText(_assets, "Opacity Words", _canvas, new Vector3(0, -42, 0)));
    }

    void AddVoice()
    {
        var commands = new List<VoiceCommand>();
        // A command names the state to which it leads, because a wearer who hears no confirmation says it again.
        AddCommand(commands, "overlay connect", nameof(CellActions.Connect));
        AddCommand(commands, "overlay disconnect", nameof(CellActions.Disconnect));
        AddCommand(commands, "overlay lock base", nameof(CellActions.LockBase));
        AddCommand(commands, "overlay panel", nameof(CellActions.SetPanel), true);
        AddCommand(commands, "overlay hide panel", nameof(CellActions.SetPanel), false);
        AddCommand(commands, "overlay ghost", nameof(CellActions.SetGhost), true);
        AddCommand(commands, "overlay hide ghost", nameof(CellActions.SetGhost), false);
        AddCommand(commands, "overlay occlusion", nameof(CellActions.SetOcclusion), true);
        AddCommand(commands, "overlay no occlusion", nameof(CellActions.SetOcclusion), false);
        AddCommand(commands, "overlay ahead", nameof(CellActions.ChangeNudgeMs), NudgeStepMs);
        AddCommand(commands, "overlay behind", nameof(CellActions.ChangeNudgeMs), -NudgeStepMs);
        AddCommand(commands, "overlay stronger", nameof(CellActions.ChangeOpacity), OpacityStep);
        AddCommand(commands, "overlay fainter", nameof(CellActions.ChangeOpacity), -OpacityStep);
        AddCommand(commands, "overlay forward", nameof(CellActions.ChangeShiftMm), ShiftStepMm);
        AddCommand(commands, "overlay backward", nameof(CellActions.ChangeShiftMm), -ShiftStepMm);
        AddCommand(commands, "overlay mark", nameof(CellActions.AddMark));
        AddCommand(commands, "overlay apply", nameof(CellActions.ApplyMarks));
        AddCommand(commands, "overlay clear", nameof(CellActions.ClearMarks));
        Fields.Set(_root.AddComponent<VoiceCommands>(), "_commands", commands);
    }

    const string Clicked = "<OnClicked>k__BackingField";

    void Toggle(string field, string words, string method, Vector2 place)
    {
        var toggle = _buttons.Toggle(words, words, place);
        Fields.Set(_menu, field, toggle);
        Click(toggle, method);
    }

    void Click(StatefulInteractable button, string method) => Calls.Add(button, Clicked, _actions, method);

    void Slide(string field, Slider slider, string method)
    {
        Fields.Set(_menu, field, slider);
        Calls.AddDynamic(slider, "onValueUpdated", _menu, method);
    }

    void AddCommand(List<VoiceCommand> commands, string keyword, string method, object argument = null)
    {
        var command = new VoiceCommand();
        Fields.Set(command, "_keyword", keyword);
        Calls.Add(command.OnHeard, _actions, method, argument);
        commands.Add(command);
    }
}
