using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>A script that notes each message with the name of its object, and runs the action that the test has set for the message.</summary>
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
