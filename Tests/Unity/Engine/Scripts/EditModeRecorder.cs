using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Scripts;

[ExecuteAlways]
sealed class EditModeRecorder : Recorder
{
}
