namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Finds Unity's built-in assets by their fileIDs, which are the same in all projects.</summary>
static class BuiltInAssets
{
    const string DefaultResources = "0000000000000000e000000000000000";
    const string ExtraResources = "0000000000000000f000000000000000";

    static readonly Dictionary<AssetReference, Object> ByReference = new Dictionary<AssetReference, Object>
    {
        [Default(10202)] = BuiltIn.Mesh(PrimitiveType.Cube),
        [Default(10206)] = BuiltIn.Mesh(PrimitiveType.Cylinder),
        [Default(10207)] = BuiltIn.Mesh(PrimitiveType.Sphere),
        [Default(10208)] = BuiltIn.Mesh(PrimitiveType.Capsule),
        [Default(10209)] = BuiltIn.Mesh(PrimitiveType.Plane),
        [Default(10210)] = BuiltIn.Mesh(PrimitiveType.Quad),
        [DefaultMaterial] = BuiltIn.DefaultMaterial,
        [FontMaterial] = BuiltIn.FontMaterial,
    };

    static readonly Dictionary<Object, AssetReference> ByObject = ByReference.ToDictionary(b => b.Value, b => b.Key);

    /// <summary>Reference to the default font: Arial, or LegacyRuntime since Unity 2022.2. The stand-in has no fonts.</summary>
    public static AssetReference Font => Default(10102);

    /// <summary>Reference to the material of the default font.</summary>
    public static AssetReference FontMaterial => Default(10100);

    public static AssetReference DefaultMaterial => new AssetReference(10303, ExtraResources, AssetReference.BuiltIn);

    public static bool Holds(AssetReference reference) => reference.Guid == DefaultResources || reference.Guid == ExtraResources;

    /// <summary>Returns a built-in asset; null if the stand-in does not have it.</summary>
    public static Object Find(AssetReference reference) => ByReference.TryGetValue(reference, out var found) ? found : null;

    public static bool TryFind(Object builtIn, out AssetReference reference) => ByObject.TryGetValue(builtIn, out reference);

    static AssetReference Default(long fileId) => new AssetReference(fileId, DefaultResources, AssetReference.BuiltIn);
}
