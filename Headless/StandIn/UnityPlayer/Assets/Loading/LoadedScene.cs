using Nowpose.UnityPlayer.Assets.Yaml;
using UnityEngine;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>The objects and settings of a scene file. The objects have not received Awake and are not in a scene yet.</summary>
/// <param name="Roots">Root objects of the scene in order.</param>
/// <param name="Settings">Settings of the whole scene.</param>
sealed record LoadedScene(IReadOnlyList<GameObject> Roots, IReadOnlyList<UnityDocument> Settings);
