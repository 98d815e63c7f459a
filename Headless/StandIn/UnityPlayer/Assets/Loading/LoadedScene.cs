using System.Collections.Generic;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>The objects and settings of a scene file. The objects have not received Awake and are not in a scene yet.</summary>
sealed class LoadedScene
{
    public LoadedScene(IReadOnlyList<GameObject> roots, IReadOnlyList<UnityDocument> settings)
    {
        Roots = roots;
        Settings = settings;
    }

    public IReadOnlyList<GameObject> Roots { get; }

    /// <summary>Settings of the whole scene.</summary>
    public IReadOnlyList<UnityDocument> Settings { get; }
}
