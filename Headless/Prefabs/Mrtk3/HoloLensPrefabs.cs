using Nowpose.Mrtk3;
using Nowpose.Unity;
using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>What the wearer of a HoloLens grasps, reads and answers.</summary>
static class HoloLensPrefabs
{
    /// <summary>Its own transform is the robot's base frame.</summary>
    public static string Marker(Workshop workshop)
    {
        var marker = new GameObject("Hand-Placed Marker");
        AnyHeadsetScene.AddShape(workshop, marker.transform);
        var placed = marker.AddComponent<HandPlacedMarker>();
        var manipulator = Graspable.Make(marker, null, new Vector3(0.1f, 0.1f, 0.1f));
        var graspable = marker.AddComponent<GraspableMarker>();
        Fields.Set(graspable, "_marker", placed);
        Fields.Set(graspable, "_manipulator", manipulator);
        return workshop.Prefab(marker);
    }

    /// <summary>The package's panel with a bar to hold it by, which pins it, and closes it.</summary>
    public static string Panel(Workshop workshop)
    {
        var panel = new GameObject("Status Panel (MRTK3)");
        var follow = panel.AddComponent<BodyFollow>();
        var cell = Texts.Add(workshop, "Cell", panel.transform, TextAnchor.UpperLeft, TextAlignment.Left);
        cell.gameObject.SetActive(false);
        var status = panel.AddComponent<StatusPanel>();
        Fields.Set(status, "_cell", cell);
        Fields.Set(status, "_ground", workshop.Load<Material>(PackagePaths.Panel));

        // Below the rows, which reach down to 0.23 m where the panel follows, and before them where it is put farther away.
        var bar = Child("Bar", panel.transform, new Vector3(0, -0.27f, -0.02f));
        var canvas = Canvases.Add(bar.transform, Vector3.zero);
        Canvases.AddGround(workshop, canvas, new Vector3(0, 0, 4), new Vector2(140, 40));
        var buttons = new Buttons(workshop, canvas);
        var pin = buttons.Toggle("Pin", "Stay", new Vector2(-50, 0));
        var close = buttons.Button("Close", "Close", new Vector2(50, 0));
        var graspable = panel.AddComponent<GraspablePanel>();
        Fields.Set(graspable, "_follow", follow);
        // Between the two buttons, so that nobody moves it when he presses one.
        Fields.Set(graspable, "_manipulator", Graspable.Make(bar, panel.transform, new Vector3(0.06f, 0.036f, 0.01f)));
        Fields.Set(graspable, "_pin", pin);
        Calls.Add(pin, "<OnClicked>k__BackingField", graspable, nameof(GraspablePanel.TogglePinned));
        Calls.Add(close, "<OnClicked>k__BackingField", panel, nameof(GameObject.SetActive), false);
        return workshop.Prefab(panel);
    }

    /// <summary>Follows the wearer, before the panel and within reach, for a question that is not seen is not answered.</summary>
    public static string Consent(Workshop workshop)
    {
        var root = new GameObject("Consent Prompt");
        Fields.Set(root.AddComponent<BodyFollow>(), "_distanceMetres", 0.6f);
        var prompt = root.AddComponent<ConsentPrompt>();
        var content = Child("Content", root.transform, Vector3.zero);
        var canvas = Canvases.Add(content.transform, Vector3.zero);
        Canvases.AddGround(workshop, canvas, new Vector3(0, 0, 4), new Vector2(400, 180));
        var question = Canvases.AddText(workshop, "Question", canvas, new Vector3(0, 40, 0));
        question.transform.localScale *= 1.5f;
        var buttons = new Buttons(workshop, canvas);
        var accept = buttons.Button("Accept", "Accept", new Vector2(-40, -60));
        var refuse = buttons.Button("Refuse", "Refuse", new Vector2(40, -60));
        Fields.Set(prompt, "_content", content);
        Fields.Set(prompt, "_question", question);
        Fields.Set(prompt, "_accept", accept);
        Fields.Set(prompt, "_refuse", refuse);
        Calls.Add(accept, "<OnClicked>k__BackingField", prompt, nameof(ConsentPrompt.Accept));
        Calls.Add(refuse, "<OnClicked>k__BackingField", prompt, nameof(ConsentPrompt.Refuse));
        content.SetActive(false);
        return workshop.Prefab(root);
    }

    static GameObject Child(string name, Transform parent, Vector3 place)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, worldPositionStays: false);
        child.transform.localPosition = place;
        return child;
    }
}
