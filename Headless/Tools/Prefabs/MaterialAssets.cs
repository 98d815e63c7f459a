using UnityEngine;

namespace Nowpose.Prefabs;

static class MaterialAssets
{
    /// <summary>Render queue before transparent objects. Used for the background of text, which must be drawn before the text.</summary>
    const int BehindText = 2900;

    /// <summary>Render queue of opaque objects.</summary>
    const int Opaque = 2000;

    /// <summary>
    /// Render queue after the virtual parts. An object in this queue does not hide the virtual parts behind it, because they are already drawn.
    /// </summary>
    const int AfterVirtualParts = 3100;

    /// <summary>Creates the material of virtual parts. It is bright, because a headset's display can only add light.</summary>
    public static string Hologram(PackageAssets assets) => Make(assets, "Hologram", new Color(0.25f, 0.75f, 1, 1));

    /// <summary>
    /// Creates the material of the arm in scenes without a real arm. It fades and has stripes like the tool, but in another colour.
    /// </summary>
    public static string Arm(PackageAssets assets) => Make(assets, "Arm", new Color(1, 0.55f, 0.15f, 1));

    /// <summary>Creates the material of workpieces. It is yellow to distinguish a workpiece from the gripper that holds it.</summary>
    public static string Workpiece(PackageAssets assets) => Make(assets, "Workpiece", new Color(1, 0.85f, 0.2f, 1));

    /// <summary>
    /// Creates the material of the uncompensated pose. It is grey and half transparent, so that it differs in more than its colour.
    /// </summary>
    public static string Ghost(PackageAssets assets) => Make(assets, "Ghost", new Color(0.8f, 0.8f, 0.8f, 0.4f), AfterVirtualParts);

    /// <summary>
    /// Creates the material of real objects in a desktop scene. It is grey, and shaded even without a light in both render pipelines.
    /// </summary>
    public static string Solid(PackageAssets assets) => Make(assets, "Solid", new Color(0.6f, 0.6f, 0.6f, 1), Opaque);

    /// <summary>Creates the material of text that objects in front of it can hide.</summary>
    public static string Text(PackageAssets assets)
    {
        var material = new Material(assets.Load<Shader>(PackagePaths.TextShader)) { name = "Text", color = Color.white, enableInstancing = true };
        material.SetFloat("_Cutoff", 0.3f);
        return assets.Asset(material);
    }

    public static string Occluder(PackageAssets assets)
    {
        return assets.Asset(new Material(assets.Load<Shader>(PackagePaths.OccluderShader)) { name = "Occluder", enableInstancing = true });
    }

    /// <summary>
    /// Creates the dark material behind the status panel's text. It is nearly invisible on a headset; in the editor, it serves as a background.
    /// It writes no depth, so that it does not hide the virtual parts behind it.
    /// </summary>
    public static string Panel(PackageAssets assets) => Make(assets, "Panel", new Color(0.05f, 0.07f, 0.1f, 0.8f), BehindText, writesDepth: false);

    /// <summary>Creates the material of a code's lit squares, which are as bright as possible.</summary>
    public static string Timestamp(PackageAssets assets) => Make(assets, "Timestamp", Color.white);

    static string Make(PackageAssets assets, string name, Color colour, int renderQueue = -1, bool writesDepth = true)
    {
        var material = new Material(assets.Load<Shader>(PackagePaths.HologramShader))
        {
            name = name,
            color = colour,
            renderQueue = renderQueue,
            enableInstancing = true,
        };
        material.SetFloat("_Fade", 0);
        material.SetFloat("_Hatch", 0);
        if (!writesDepth) material.SetFloat("_ZWrite", 0);
        return assets.Asset(material);
    }
}
