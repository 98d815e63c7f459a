using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>Notes each message with its object's name, and runs the test's action for it.</summary>
class Recorder : MonoBehaviour
{
    public Dictionary<string, Action> On { get; } = [];

    void Awake() => Note("Awake");
    void OnEnable() => Note("OnEnable");
    void Start() => Note("Start");
    void Update() => Note("Update");
    void LateUpdate() => Note("LateUpdate");
    void OnDisable() => Note("OnDisable");
    void OnDestroy() => Note("OnDestroy");

    protected virtual string Label => name;

    void Note(string message)
    {
        Journal.Note($"{Label}.{message}");
        if (On.TryGetValue(message, out var action)) action();
    }
}
