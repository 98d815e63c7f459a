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
            EditorGUILayout.LabelField("Follows", InspectorTexts.Following(head.name, follow.IsGliding));
            EditorGUILayout.LabelField(
                InspectorTexts.BesideView, LiveText.Number(Mathf.Abs(aside), "0", aside < 0 ? InspectorTexts.DegreesLeft : InspectorTexts.DegreesRight));
            EditorGUILayout.LabelField(InspectorTexts.FromHead, LiveText.Number(Vector3.Distance(follow.transform.position, head.position), "0.00", " m"));
        }
    }
}
