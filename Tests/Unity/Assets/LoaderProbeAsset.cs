using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

public sealed class LoaderProbeAsset : ScriptableObject
{
    [SerializeField] string _text = "";
    [SerializeField] LoaderProbeAsset _next = null;

    public string Text => _text;
    public LoaderProbeAsset Next => _next;

    public string TextOnEnable { get; private set; }

    void OnEnable() => TextOnEnable = _text;
}
