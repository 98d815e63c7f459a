using System;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>Resolves the references of one file.</summary>
interface IReferences
{
    /// <summary>Returns the object to which a reference refers.</summary>
    /// <param name="reference">The reference, which must not be empty.</param>
    /// <param name="type">Type of the field that contains the reference.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">The object does not exist, or its type does not fit the field.</exception>
    Object ObjectAt(AssetReference reference, Type type, Place place);

    /// <summary>Returns the reference to an object.</summary>
    /// <param name="target">The object, which must not be null or destroyed.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">The object is neither in this file nor an asset of the library.</exception>
    AssetReference ReferenceTo(Object target, Place place);

    /// <summary>Returns the reference to the script file of a class.</summary>
    /// <param name="type">Type of a component or ScriptableObject in a script.</param>
    /// <param name="place">Place for error messages.</param>
    /// <exception cref="AssetException">No script file exists for this class.</exception>
    AssetReference ScriptOf(Type type, Place place);

    /// <summary>Returns the index of a transform among the children of its parent, or among the roots of the file.</summary>
    int SiblingIndex(Transform transform);
}
