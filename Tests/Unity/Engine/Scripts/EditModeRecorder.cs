using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

[ExecuteAlways]
sealed class EditModeRecorder : Recorder
{
}
