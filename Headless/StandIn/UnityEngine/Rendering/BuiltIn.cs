namespace UnityEngine;

/// <summary>Unity's built-in resources: the meshes of the primitives, the default material, and the material of the font.</summary>
static class BuiltIn
{
    // The resources belong to the whole process, as in Unity, so they have a world of their own. They are never changed or destroyed.
    static readonly World Own = new(isPlaying: false, (_, _, _, _) => { });

    static Material s_material;
    static Material s_fontMaterial;
    static readonly Mesh[] Meshes = new Mesh[6];

    internal static Material DefaultMaterial => s_material ? s_material : s_material = Make("Default-Material", "Standard");

    internal static Material FontMaterial => s_fontMaterial ? s_fontMaterial : s_fontMaterial = MakeFontMaterial();

    /// <summary>Returns the mesh of a primitive. It is a box with the documented size of the primitive, because nothing draws it.</summary>
    internal static Mesh Mesh(PrimitiveType type)
    {
        if (Meshes[(int)type]) return Meshes[(int)type];

        using (Own.Enter())
        {
            return Meshes[(int)type] = AsAsset(Box(type.ToString(), type switch
            {
                PrimitiveType.Capsule or PrimitiveType.Cylinder => new Vector3(1, 2, 1),
                PrimitiveType.Plane => new Vector3(10, 0, 10),
                PrimitiveType.Quad => new Vector3(1, 1, 0),
                _ => Vector3.one,
            }));
        }
    }

    /// <summary>
    /// Returns the built-in resource with this file name in Unity; null if the stand-in does not have it. Fonts are missing, because nothing draws
    /// text.
    /// </summary>
    internal static Object Resource(string path) => path switch
    {
        "Cube.fbx" => Mesh(PrimitiveType.Cube),
        "New-Sphere.fbx" => Mesh(PrimitiveType.Sphere),
        "New-Cylinder.fbx" => Mesh(PrimitiveType.Cylinder),
        "New-Capsule.fbx" => Mesh(PrimitiveType.Capsule),
        "New-Plane.fbx" => Mesh(PrimitiveType.Plane),
        "Quad.fbx" => Mesh(PrimitiveType.Quad),
        _ => null,
    };

    static Material Make(string name, string shader)
    {
        using (Own.Enter()) return AsAsset(new Material(AsAsset(new Shader { name = shader })) { name = name });
    }

    static Material MakeFontMaterial()
    {
        var made = Make("Font Material", "GUI/Text Shader");
        using (Own.Enter()) made.mainTexture = AsAsset(new Texture2D(256, 256) { name = "Font Texture" });
        return made;
    }

    static T AsAsset<T>(T made) where T : Object
    {
        made.BecomeAsset();
        return made;
    }

    static Mesh Box(string name, Vector3 size)
    {
        var corners = new Vector3[8];
        for (var i = 0; i < 8; i++) corners[i] = Vector3.Scale(new Vector3((i & 1) - 0.5f, (i & 2) / 2f - 0.5f, (i & 4) / 4f - 0.5f), size);
        return new Mesh
        {
            name = name,
            vertices = corners,
            triangles = new[]
            {
                0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
            },
        };
    }
}
