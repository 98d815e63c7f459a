using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

[DefaultExecutionOrder(10)]
sealed class LateRecorder : Recorder
{
}
