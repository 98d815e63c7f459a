using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(BodyFollow))]
    [CanEditMultipleObjects]
    sealed class BodyFollowEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var follow = (BodyFollow)target;
            var head = follow.Head;
            if (head == null)
            {
                EditorGUILayout.LabelField("Follows", InspectorTexts.NoHead);
                return;
            }
            var place = AroundHead.Of(follow.transform.position, head.position);
            var aside = Mathf.DeltaAngle(AroundHead.HeadingOf(head.rotation), place.Azimuth);
            EditorGUILayout.LabelField("Follows", head.name + (follow.IsGliding ? ", gliding" : ", staying put"));
            EditorGUILayout.LabelField("Beside the view", LiveText.Number(Mathf.Abs(aside), "0", aside < 0 ? "° to the left" : "° to the right"));
            EditorGUILayout.LabelField("From the head", LiveText.Number(Vector3.Distance(follow.transform.position, head.position), "0.00", " m"));
        }
    }
}
