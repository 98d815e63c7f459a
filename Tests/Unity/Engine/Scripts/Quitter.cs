using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

sealed class Quitter : MonoBehaviour
{
    void OnApplicationPause(bool paused) => Journal.Note($"{name}.Pause({paused})");
    void OnApplicationFocus(bool focused) => Journal.Note($"{name}.Focus({focused})");
    void OnApplicationQuit() => Journal.Note($"{name}.Quit");
    void OnDisable() => Journal.Note($"{name}.OnDisable");
    void OnDestroy() => Journal.Note($"{name}.OnDestroy");
}
