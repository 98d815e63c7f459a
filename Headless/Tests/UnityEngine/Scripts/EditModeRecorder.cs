using UnityEngine;

namespace Nowpose.Headless.Tests.Engine;

[ExecuteAlways]
sealed class EditModeRecorder : Recorder
{
}
