using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Creates materials with the kinds of shaders that users have.</summary>
public static class UserMaterials
{
    /// <summary>Values of <c>_SrcBlend</c>.</summary>
    public const int One = 1, SourceAlpha = 5;

    /// <summary>Kinds of materials: with the pattern of the package's shaders, blended in several ways, or opaque.</summary>
    public enum Sort
    {
        Patterned, Blended, BlendedUniversal, Premultiplied, BlendedUnknown, OpaqueDrawnLate, Opaque, OpaqueWithColour, OppositeFade, Several,
        SeveralOppositeFade, Missing,
    }

    public static Material NewMaterial(string name, params (string Name, float Value)[] floats)
    {
        var material = new Material((Shader)null) { name = name, renderQueue = 2000 };
        foreach (var (property, value) in floats) material.SetFloat(property, value);
        return material;
    }

    public static Material Blended(string colour, float alpha, int? sourceBlend = SourceAlpha)
    {
        var material = NewMaterial("Glass");
        material.renderQueue = 3000;
        if (sourceBlend.HasValue) material.SetFloat("_SrcBlend", sourceBlend.Value);
        material.SetColor(colour, new Color(1, 0.5f, 0.25f, alpha));
        return material;
    }

    public static Material[] Of(Sort sort)
    {
        var coloured = NewMaterial("Steel");
        coloured.SetColor("_Color", Color.white);
        switch (sort)
        {
            case Sort.Patterned: return [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0))];
            case Sort.Blended: return [Blended("_Color", 0.8f)];
            case Sort.BlendedUniversal: return [Blended("_BaseColor", 0.8f)];
            case Sort.Premultiplied: return [Blended("_Color", 0.8f, One)];
            case Sort.BlendedUnknown: return [Blended("_Color", 0.8f, null)];
            case Sort.OpaqueDrawnLate: return [Blended("_Color", 1, One)];
            case Sort.OppositeFade: return [NewMaterial("Brass", ("_Fade", 1))];
            case Sort.SeveralOppositeFade: return [NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0)), NewMaterial("Brass", ("_Fade", 1))];
            case Sort.Missing: return [null];
            case Sort.Opaque: return [NewMaterial("Steel")];
            case Sort.OpaqueWithColour: return [coloured];
            default: return [coloured, Blended("_Color", 1), NewMaterial("Hologram", ("_Fade", 0), ("_Hatch", 0))];
        }
    }
}
