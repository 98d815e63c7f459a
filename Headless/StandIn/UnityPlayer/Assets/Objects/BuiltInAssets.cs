using System.Collections.Generic;
using System.Linq;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Objects;

/// <summary>Unity's built-in assets by their fileIDs, which are the same in every project.</summary>
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

    /// <summary>The default font: Arial, or LegacyRuntime from Unity 2022.2 on. The stand-in has no fonts.</summary>
    public static AssetReference Font => Default(10102);

    /// <summary>The material of that font.</summary>
    public static AssetReference FontMaterial => Default(10100);

    public static AssetReference DefaultMaterial => new AssetReference(10303, ExtraResources, AssetReference.BuiltIn);

    public static bool Holds(AssetReference reference) => reference.Guid == DefaultResources || reference.Guid == ExtraResources;

    /// <summary>Gets a built-in asset; null if it is unknown here.</summary>
    public static Object Find(AssetReference reference) => ByReference.TryGetValue(reference, out var found) ? found : null;

    public static bool TryFind(Object builtIn, out AssetReference reference) => ByObject.TryGetValue(builtIn, out reference);

    static AssetReference Default(long fileId) => new AssetReference(fileId, DefaultResources, AssetReference.BuiltIn);
}
