using UnityEngine;

namespace Nowpose.Headless.Tests.Engine;

[DefaultExecutionOrder(-10)]
sealed class EarlyRecorder : Recorder
{
}
