using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

/// <summary>A script that throws in the message that the test selects.</summary>
sealed class Thrower : MonoBehaviour
{
    public static string In { get; set; } = "";

    void Awake() => Throw("Awake");
    void OnEnable() => Throw("OnEnable");
    void Start() => Throw("Start");
    void Update() => Throw("Update");
    void OnDisable() => Throw("OnDisable");
    void OnDestroy() => Throw("OnDestroy");

    static void Throw(string message)
    {
        Journal.Note(message);
        if (message == In) throw new InvalidOperationException("thrown in " + message);
    }
}
