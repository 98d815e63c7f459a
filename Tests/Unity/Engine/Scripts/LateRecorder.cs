using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

[DefaultExecutionOrder(10)]
sealed class LateRecorder : Recorder
{
}
