using System;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Resolves the references of one file.</summary>
interface IReferences
{
    /// <param name="reference">The reference; must not be empty.</param>
    /// <param name="type">Type of the field.</param>
    /// <param name="place">Place for errors.</param>
    /// <exception cref="AssetException">The object does not exist, or has a type that the field does not accept.</exception>
    Object ObjectAt(AssetReference reference, Type type, Place place);

    /// <param name="target">The object; neither null nor destroyed.</param>
    /// <param name="place">Place for errors.</param>
    /// <exception cref="AssetException">The object is not in a file that this one may refer to.</exception>
    AssetReference ReferenceTo(Object target, Place place);

    /// <param name="type">A component or ScriptableObject class of the user.</param>
    /// <param name="place">Place for errors.</param>
    /// <exception cref="AssetException">No script file contains this class.</exception>
    AssetReference ScriptOf(Type type, Place place);

    /// <summary>Gets its index among the children of its parent, or among the file's roots.</summary>
    int SiblingIndex(Transform transform);
}
