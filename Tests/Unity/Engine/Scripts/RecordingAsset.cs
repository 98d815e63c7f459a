using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

sealed class RecordingAsset : ScriptableObject
{
    [SerializeField] int _number = 1;

    public int Number { get => _number; set => _number = value; }

    void Awake() => Journal.Note("Awake");
    void OnEnable() => Journal.Note("OnEnable");
    void OnDisable() => Journal.Note("OnDisable");
    void OnDestroy() => Journal.Note("OnDestroy");
}
