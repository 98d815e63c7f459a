using Nowpose.Unity;
using Nowpose.UnityPlayer.Assets.Objects;
using UnityEngine;

namespace Nowpose.Prefabs;

static class Texts
{
    /// <summary>Font size at which the font's texture is generated. At this size, letters are sharp at arm's length.</summary>
    const int Points = 48;

    /// <summary>Scale at which letters are half a degree high at 1 m. Components adapt it to the distance from the user.</summary>
    const float Scale = 0.0035f;

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
