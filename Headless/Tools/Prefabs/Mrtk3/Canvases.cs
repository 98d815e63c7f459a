using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Yaml;

namespace Nowpose.Prefabs.Mrtk3;

/// <summary>Creates canvases whose unit is 1 mm, and their contents.</summary>
static class Canvases
{
    const float Millimetre = 0.001f;

    /// <summary>Scale at which letters are half a degree high at 0.45 m, the distance of a hand.</summary>
    const float TextScale = 1.6f;

    public static Transform Add(Transform parent, Vector3 place)
    {
        var made = new GameObject("Canvas");
        var rect = made.AddComponent<RectTransform>();
        rect.SetParent(parent, worldPositionStays: false);
        rect.localPosition = place;
        rect._anchoredPosition = new Vector2(place.x, place.y);
        rect._sizeDelta = Vector2.zero;
        rect.localScale = new Vector3(Millimetre, Millimetre, Millimetre);
        var canvas = made.AddComponent<OpaqueComponent>();
        canvas.ClassName = "Canvas";
        foreach (var (name, value) in CanvasFields().Children) canvas.Fields.Add(name, value);
        return rect;
    }

    /// <summary>Adds the background of the buttons.</summary>
    public static void AddGround(PackageAssets assets, Transform canvas, Vector3 place, Vector2 size) => Children.AddPrimitive(
        PrimitiveType.Quad, "Ground", canvas, place, new Vector3(size.x, size.y, 1), assets.Load<Material>(PackagePaths.Panel));

    public static TextMesh AddText(PackageAssets assets, string name, Transform canvas, Vector3 place)
    {
        var text = Texts.Add(assets, name, canvas, TextAnchor.MiddleCenter, TextAlignment.Center);
        text.transform.localPosition = place;
        text.transform.localScale = new Vector3(TextScale, TextScale, TextScale);
        return text;
    }

    /// <summary>Gets the fields of a world-space canvas, with the vertex data that MRTK3's canvases require.</summary>
    static YamlDotNet.RepresentationModel.YamlMappingNode CanvasFields() => Nodes.Lines(
        ("m_Enabled", Nodes.Number(1)),
        ("serializedVersion", Nodes.Number(3)),
        ("m_RenderMode", Nodes.Number(2)),
        ("m_Camera", AssetReference.None.Write()),
        ("m_PlaneDistance", Nodes.Number(100)),
        ("m_PixelPerfect", Nodes.Number(0)),
        ("m_ReceivesEvents", Nodes.Number(1)),
        ("m_OverrideSorting", Nodes.Number(0)),
        ("m_OverridePixelPerfect", Nodes.Number(0)),
        ("m_SortingBucketNormalizedSize", Nodes.Number(0)),
        ("m_AdditionalShaderChannelsFlag", Nodes.Number(31)),
        ("m_SortingLayerID", Nodes.Number(0)),
        ("m_SortingOrder", Nodes.Number(0)),
        ("m_TargetDisplay", Nodes.Number(0)));
}
