using MixedReality.Toolkit.SpatialManipulation;
using MixedReality.Toolkit.UX;
using TMPro;
using Unity.XR.CoreUtils;
using UnityEngine;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>
/// Creates stand-ins for MRTK3's prefabs. They contain the objects that the sample changes or calls, with the original values and fileIDs.
/// </summary>
static class ForeignPrefabs
{
    /// <summary>
    /// FileID of the button's instance in the checkbox, which is a variant of the button. Unity computes the fileIDs of the checkbox's objects
    /// from this value and those of the button's objects.
    /// </summary>
    const long CheckboxInstance = 2843419059293016730;

    public static string Button(PackageAssets assets) => Button(assets, "Action Button", id => id, hasLabel: false);

    public static string Toggle(PackageAssets assets) =>
        Button(assets, "Action Button Checkbox", id => (id ^ CheckboxInstance) & long.MaxValue, hasLabel: true);

    public static string Slider(PackageAssets assets)
    {
        var root = ForeignObject.Root<RectTransform>("CanvasSlider", 5677198132984834579, 5677198132984834578);
        root.Add<Slider>(5677198132984834573);
        Place(root, new Vector2(30.019f, -11.0733f), new Vector2(100, 20));
        return assets.Foreign(root);
    }

    public static string HandMenu(PackageAssets assets)
    {
        var root = ForeignObject.Root<Transform>("HandMenuBase", 1947121577341454423, 1947121577341454504);
        root.Add<SolverHandler>(6529426809915133304);
        var solver = root.Add<HandConstraintPalmUp>(1947121577341454505);
        var canvas = root.Child<RectTransform>("MenuContent-Canvas", 1947121578436813678, 7332201463210307094);
        canvas.GameObject.transform.localScale = new Vector3(0.001f, 0.001f, 0.001f);
        Place(canvas, new Vector2(-0.0158f, 0), Vector2.zero);
        Place(canvas.Child<RectTransform>("Buttons-GridLayout", 8337109874524864710, 7083505145275335002), Vector2.zero, new Vector2(40, 0));
        Calls.Add(solver, "onFirstHandDetected", canvas.GameObject, nameof(GameObject.SetActive), true);
        Calls.Add(solver, "onLastHandLost", canvas.GameObject, nameof(GameObject.SetActive), false);
        return assets.Foreign(root);
    }

    public static string Rig(PackageAssets assets)
    {
        var root = ForeignObject.Root<Transform>("MRTK XR Rig", 2351505567455720334, 2351505567455720332);
        var offset = root.Child<Transform>("Camera Offset", 2351505566903569413, 2351505566903569412);
        var origin = offset.Add<XROrigin>(3712792914886690938);
        var head = offset.Child<Transform>("Main Camera", 2351505566771328562, 2351505566771328526);
        head.GameObject.tag = "MainCamera";
        var camera = head.Add<Camera>(2351505566771328527);
        camera.clearFlags = CameraClearFlags.SolidColor;
        camera.backgroundColor = new Color(0, 0, 0, 0);
        camera.nearClipPlane = 0.02f;
        camera.farClipPlane = 100;
        Fields.Set(origin, "m_Camera", camera);
        Fields.Set(origin, "m_OriginBaseGameObject", root.GameObject);
        Fields.Set(origin, "m_CameraFloorOffsetObject", offset.GameObject);
        return assets.Foreign(root);
    }

    public static string Simulator(PackageAssets assets) =>
        assets.Foreign(ForeignObject.Root<Transform>("MRTKInputSimulator", 7585035320575375756, 3493013819197874656));

    static string Button(PackageAssets assets, string name, Func<long, long> id, bool hasLabel)
    {
        var root = ForeignObject.Root<RectTransform>(name, id(8376646494505211202), id(8376646494505211229));
        root.Add<PressableButton>(id(8376646494505211226));
        Place(root, Vector2.zero, new Vector2(32, 32));
        var icon = root.Child<RectTransform>("Icon", id(410843422125320171), id(7216918420766221479));
        var label = icon.Child<RectTransform>("Label", id(7594107385585372191), id(1520311476867378557));
        Write(label.Add<TextMeshProUGUI>(id(8493469810320727241)), "Label", 4.66f, 4.66f);
        label.GameObject.SetActive(hasLabel);
        var text = root.Child<RectTransform>("Text", id(2142167140070017856), id(5319578128471115350));
        Write(text.Add<TextMeshProUGUI>(id(1922220768106560367)), "Button", 8, 6);
        text.GameObject.SetActive(false);
        return assets.Foreign(root);
    }

    static void Place(ForeignObject placed, Vector2 position, Vector2 size)
    {
        var rect = (RectTransform)placed.GameObject.transform;
        rect._anchoredPosition = position;
        rect._sizeDelta = size;
    }

    static void Write(TextMeshProUGUI text, string words, float size, float baseSize)
    {
        text.m_text = words;
        text.m_fontSize = size;
        text.m_fontSizeBase = baseSize;
    }
}
