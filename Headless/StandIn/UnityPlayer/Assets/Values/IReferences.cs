using System;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.UnityPlayer.Assets.Values;

/// <summary>What the references of one file stand for.</summary>
interface IReferences
{
    /// <param name="reference">Not none.</param>
    /// <param name="type">What the field takes.</param>
    /// <param name="place">For errors.</param>
    /// <exception cref="AssetException">No such object, or one that the field does not take.</exception>
    Object ObjectAt(AssetReference reference, Type type, Place place);

    /// <param name="target">Neither null nor destroyed.</param>
    /// <param name="place">For errors.</param>
    /// <exception cref="AssetException">The object is in no file that this one may refer to.</exception>
    AssetReference ReferenceTo(Object target, Place place);

    /// <param name="type">A component or ScriptableObject of the user's.</param>
    /// <param name="place">For errors.</param>
    /// <exception cref="AssetException">No script file holds this class.</exception>
    AssetReference ScriptOf(Type type, Place place);

    /// <summary>Its place among the children of its parent, or among the file's roots.</summary>
    int SiblingIndex(Transform transform);
}
