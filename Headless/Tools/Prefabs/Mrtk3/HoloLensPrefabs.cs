using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using Nowpose.Mrtk3;
using Nowpose.Unity.Status;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Creates the prefabs for a HoloLens 2 user: a marker to grasp, a panel to read and a consent prompt to answer.</summary>
static class HoloLensPrefabs
{
    /// <summary>Size of the status panel's bar, as multiples of the panel's font size. The bar is as wide as the background of the panel.</summary>
    const float BarWidth = 31.5f, BarHeight = 2.8f;

    /// <summary>
    /// Size of one unit of the bar's canvas, as a multiple of the panel's font size. A button of 32 units is 2° high at the reading distance, which
    /// is Microsoft's minimum.
    /// </summary>
    const float BarUnit = 0.0785f;

    /// <summary>Font size, in metres, of a panel that follows the user at 1.3 m. The text is legible from up to 10 % farther away.</summary>
    static readonly float BarSize = LetterSize.At(1.3f * 1.1f);

    /// <summary>Creates the marker. Its transform is the robot's base frame.</summary>
    public static string Marker(PackageAssets assets)
    {
        var marker = new GameObject("Hand-Placed Marker");
        AnyHeadsetScene.AddShape(assets, marker.transform);
        var placed = marker.AddComponent<HandPlacedMarker>();
        var manipulator = Graspable.Make(marker, null, new Vector3(0.1f, 0.1f, 0.1f));
        var graspable = marker.AddComponent<GraspableMarker>();
        Fields.Set(graspable, "_marker", placed);
        Fields.Set(graspable, "_manipulator", manipulator);
        return assets.Prefab(marker);
    }

    /// <summary>Creates the package's panel with a bar by which the user grasps, pins and closes it.</summary>
    public static string Panel(PackageAssets assets)
    {
        var panel = new GameObject("Status Panel (MRTK3)");
        var follow = panel.AddComponent<BodyFollow>();
        var cell = Texts.Add(assets, "Cell", panel.transform, TextAnchor.UpperLeft, TextAlignment.Left);
        cell.gameObject.SetActive(false);
        var status = panel.AddComponent<StatusPanel>();
        Fields.Set(status, "_cell", cell);
        Fields.Set(status, "_ground", assets.Load<Material>(PackagePaths.Backdrop));

        var bar = AddBar(assets, panel.transform, out var handle, out var pin, out var close);
        Fields.Set(status, "_bar", bar);
        var graspable = panel.AddComponent<GraspablePanel>();
        Fields.Set(graspable, "_follow", follow);
        Fields.Set(graspable, "_manipulator", handle);
        Fields.Set(graspable, "_pin", pin);
        Calls.Add(pin, "<OnClicked>k__BackingField", graspable, nameof(GraspablePanel.TogglePinned));
        Calls.Add(close, "<OnClicked>k__BackingField", panel, nameof(GameObject.SetActive), false);
        return assets.Prefab(panel);
    }

    /// <summary>Adds the bar below the panel. Its unit of length is the panel's font size.</summary>
    /// <returns>The object that the panel places and scales, so that the bar looks the same in the editor and on a following panel.</returns>
    static Transform AddBar(
        PackageAssets assets, Transform panel, out ObjectManipulator handle, out PressableButton pin, out PressableButton close)
    {
        var bar = Children.Add("Bar Place", panel, new Vector3(0, PanelCells.LowerEdge * BarSize, 0)).transform;
        bar.localScale = Vector3.one * BarSize;
        var content = Children.Add("Bar", bar, new Vector3(0, -BarHeight / 2 - 0.15f, -0.3f));
        var canvas = Canvases.Add(content.transform, Vector3.zero);
        canvas.localScale = Vector3.one * BarUnit;
        Canvases.AddGround(assets, canvas, new Vector3(0, 0, 4), new Vector2(BarWidth / BarUnit, BarHeight / BarUnit));
        var buttons = new Buttons(assets, canvas);
        pin = buttons.Toggle("Pin", "", new Vector2(-170, 0), keyword: "stay");
        AddWord(assets, "Stay", canvas, new Vector3(-120, 0, 0));
        close = buttons.Button("Close", "×", new Vector2(170, 0), keyword: "close");
        AddWord(assets, "Close", canvas, new Vector3(115, 0, 0));
        // The grasped area is between the two labels, so that pressing a button does not move the panel.
        handle = Graspable.Make(content, panel, new Vector3(12, BarHeight, 0.6f));
        return bar;
    }

    /// <summary>Adds a label next to a button, because the letters on the button are too small at the distance of a panel.</summary>
    static void AddWord(PackageAssets assets, string word, Transform canvas, Vector3 place)
    {
        var text = Canvases.AddText(assets, word + " Word", canvas, place);
        text.text = word;
        text.transform.localScale = Vector3.one / (LetterSize.Of(text) * BarUnit);
    }

    /// <summary>
    /// Creates the consent prompt. It follows the user in front of the panel and within reach, so that the user cannot overlook it. It is nearer
    /// than the surface with the code at which the user looks, and soon follows a user who steps back from this surface.
    /// </summary>
    public static string Consent(PackageAssets assets)
    {
        var root = new GameObject("Consent Prompt");
        var prompt = root.AddComponent<ConsentPrompt>();
        var content = Children.Add("Content", root.transform);
        // On the content, so that a prompt that opens appears at its distance, wherever the user has gone since the last question.
        var follow = content.AddComponent<BodyFollow>();
        Fields.Set(follow, "_distanceMetres", 0.45f);
        Fields.Set(follow, "_moveMetres", 0.2f);
        var canvas = Canvases.Add(content.transform, Vector3.zero);
        Canvases.AddGround(assets, canvas, new Vector3(0, 0, 4), new Vector2(300, 150));
        var question = Canvases.AddText(assets, "Question", canvas, new Vector3(0, 25, 0));
        question.transform.localScale *= 1.125f;
        var buttons = new Buttons(assets, canvas);
        var accept = buttons.Button("Accept", "Accept", new Vector2(-40, -45));
        var refuse = buttons.Button("Refuse", "Refuse", new Vector2(40, -45));
        // The component does the same for the buttons of the user's own prompts. MRTK3 then also shows no label with a keyword.
        Fields.Set(accept, "allowSelectByVoice", false);
        Fields.Set(prompt, "_content", content);
        Fields.Set(prompt, "_question", question);
        Fields.Set(prompt, "_accept", accept);
        Fields.Set(prompt, "_refuse", refuse);
        Calls.Add(accept, "<OnClicked>k__BackingField", prompt, nameof(ConsentPrompt.Accept));
        Calls.Add(refuse, "<OnClicked>k__BackingField", prompt, nameof(ConsentPrompt.Refuse));
        content.SetActive(false);
        return assets.Prefab(root);
    }
}
