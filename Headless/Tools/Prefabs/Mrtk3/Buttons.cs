using MixedReality.Toolkit;
using MixedReality.Toolkit.UX;
using TMPro;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Adds instances of MRTK3's buttons and sliders to a canvas at their original size: 32 mm square and 100 mm wide.</summary>
sealed class Buttons
{
    /// <summary>Z position of the original slider's handle relative to the canvas, mm; negative is towards the wearer.</summary>
    const float SliderDepth = -6.1f;

    readonly PackageAssets _assets;
    readonly Transform _canvas;

    /// <param name="canvas">The canvas. Its unit is 1 mm.</param>
    public Buttons(PackageAssets assets, Transform canvas)
    {
        _assets = assets;
        _canvas = canvas;
    }

    /// <summary>Adds a button with text in place of an icon, because only MRTK3's own font contains icons.</summary>
    /// <param name="keyword">The word that selects the button by voice while the wearer looks at it, and that MRTK3 shows at the button; null for
    /// <paramref name="words"/>.</param>
    public PressableButton Button(string name, string words, Vector2 place, string keyword = null)
    {
        var made = Instance(ForeignPaths.Button, name, place);
        made.transform.Find("Icon").gameObject.SetActive(false);
        var text = made.transform.Find("Text").gameObject;
        text.SetActive(true);
        text.GetComponent<TextMeshProUGUI>().m_text = words;
        return Spoken(made, keyword ?? words);
    }

    /// <inheritdoc cref="Button"/>
    public PressableButton Toggle(string name, string words, Vector2 place, string keyword = null)
    {
        var made = Instance(ForeignPaths.Toggle, name, place);
        made.transform.Find("Icon/Label").GetComponent<TextMeshProUGUI>().m_text = words;
        var toggle = Spoken(made, keyword ?? words);
        toggle.ToggleMode = StatefulInteractable.ToggleType.Toggle;
        return toggle;
    }

    /// <param name="steps">Number of steps between the ends; 0 for a continuous slider.</param>
    public Slider Slider(string name, float min, float max, float value, Vector2 place, int steps = 0)
    {
        var made = Instance(ForeignPaths.Slider, name, place);
        made.transform.localPosition = new Vector3(0, 0, SliderDepth);
        var slider = made.GetComponent<Slider>();
        Fields.Set(slider, "minValue", min);
        Fields.Set(slider, "maxValue", max);
        Fields.Set(slider, "value", value);
        if (steps == 0) return slider;
        Fields.Set(slider, "useSliderStepDivisions", true);
        Fields.Set(slider, "sliderStepDivisions", steps);
        return slider;
    }

    static PressableButton Spoken(GameObject made, string words)
    {
        var button = made.GetComponent<PressableButton>();
        Fields.Set(button, "speechRecognitionKeyword", words.ToLowerInvariant());
        return button;
    }

    GameObject Instance(string path, string name, Vector2 place)
    {
        var made = _assets.Instantiate(path, _canvas);
        made.name = name;
        ((RectTransform)made.transform)._anchoredPosition = place;
        return made;
    }
}
