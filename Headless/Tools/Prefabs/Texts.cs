using Nowpose.UnityPlayer.Assets.Objects;

namespace Nowpose.Prefabs;

static class Texts
{
    /// <summary>Font size at which the font's texture is generated. At this size, letters are sharp at arm's length.</summary>
    const int Points = 48;

    /// <summary>Scale at which letters are half a degree high at 1 m. Components adapt it to the distance from the user.</summary>
    const float Scale = 0.0035f;

    /// <summary>Creates the label of an object that the menu adds to a scene: above the origin of the object.</summary>
    public static string PoseLabel(PackageAssets assets)
    {
        var label = Add(assets, "Pose Label", null, TextAnchor.MiddleCenter, TextAlignment.Center);
        label.transform.localPosition = new Vector3(0, 0.1f, 0);
        return assets.Prefab(label.gameObject);
    }

    public static TextMesh Add(PackageAssets assets, string name, Transform parent, TextAnchor anchor, TextAlignment alignment)
    {
        var made = Children.Add(name, parent);
        made.transform.localScale = new Vector3(Scale, Scale, Scale);
        var renderer = made.AddComponent<MeshRenderer>();
        renderer.sharedMaterial = assets.Load<Material>(PackagePaths.Text);
        var text = made.AddComponent<TextMesh>();
        text.anchor = anchor;
        text.alignment = alignment;
        text.fontSize = Points;
        text.richText = false;
        Fields.Set(made.AddComponent<FontTexture>(), "_fontMaterial", (Material)BuiltInAssets.Find(BuiltInAssets.FontMaterial));
        return text;
    }
}
