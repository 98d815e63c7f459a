using System.Collections.Generic;
using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>The objects of a scene, created but not yet awake and not yet in a scene.</summary>
sealed class LoadedScene
{
    public LoadedScene(string name, string path, IReadOnlyList<GameObject> roots, IReadOnlyList<UnityDocument> settings)
    {
        Name = name;
        Path = path;
        Roots = roots;
        Settings = settings;
    }

    public string Name { get; }
    public string Path { get; }
    public IReadOnlyList<GameObject> Roots { get; }

    /// <summary>The settings of the scene as a whole.</summary>
    public IReadOnlyList<UnityDocument> Settings { get; }
}
